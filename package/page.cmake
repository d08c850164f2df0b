# Builds the page of kadr serve: cmake -DFROM=web -DTO=build/web -DNPM=npm -P page.cmake. Where npm's registry cannot be reached there is no
# page, which is said; all else is built.
file(COPY ${FROM}/ DESTINATION ${TO} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)
file(REMOVE_RECURSE ${TO}/dist)
if(NPM)
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 --fetch-timeout=20000
                  WORKING_DIRECTORY ${TO} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said TIMEOUT 300)
  if(status EQUAL 0)
    execute_process(COMMAND ${NPM} run --silent build WORKING_DIRECTORY ${TO} RESULT_VARIABLE status OUTPUT_VARIABLE told ERROR_VARIABLE said TIMEOUT 300)
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "the page does not build:\n${told}\n${said}")
    endif()
    return()
  endif()
  message(WARNING "the packages of the page cannot be had, kadr serve is built without it:\n${said}")
else()
  message(WARNING "there is no npm: kadr serve is built without its page (dev/setup installs nodejs and npm)")
endif()
