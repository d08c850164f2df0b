# The programs of a build for browsers: kadr_page is the engine of the page (src/web), kadr the command for Node, with which the tests compare
# it with the native program.
set(common -O2 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sTOTAL_STACK=8MB -sFORCE_FILESYSTEM=1)

kadr_room(cli JOIN 22 USES kadr_lsp fmt::fmt CLI11::CLI11 Threads::Threads)
target_compile_definitions(kadr_cli PRIVATE KADR_VERSION="${PROJECT_VERSION}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/no_report.cpp
     "#include \"cli/report_files.h\"\n\nnamespace kadr {\nstd::span<const EmbeddedFile> report_files() { return {}; }\n}\n")
add_executable(kadr ${CMAKE_CURRENT_BINARY_DIR}/no_report.cpp)
target_link_libraries(kadr PRIVATE kadr_cli)
target_link_options(kadr PRIVATE ${common} -sNODERAWFS=1 -sENVIRONMENT=node -sEXIT_RUNTIME=1)
set_target_properties(kadr PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

add_executable(kadr_page web/engine.cpp)
target_compile_definitions(kadr_page PRIVATE KADR_VERSION="${PROJECT_VERSION}")
target_link_libraries(kadr_page PRIVATE kadr_view)
target_link_options(kadr_page PRIVATE ${common} --no-entry -sENVIRONMENT=worker,node -sMODULARIZE=1 -sEXPORT_NAME=kadr_engine
                    "-sEXPORTED_RUNTIME_METHODS=FS,stringToUTF8,lengthBytesUTF8" "-sEXPORTED_FUNCTIONS=_malloc,_free")
set_target_properties(kadr_page PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
