# A thin door to the scripts of dev/.
.POSIX:
PREFIX = /usr/local
EXAMPLE = examples/s2c42/flange
PICTURE = out/flange.svg

all:
	@dev/build release

run:
	@dev/setup build
	@dev/build program kadr
	@mkdir -p out
	build/release/kadr run $(EXAMPLE).nc --control s2c42 --setup $(EXAMPLE).json --plot $(PICTURE)
	@echo "The picture is in $(PICTURE)"

test:
	@dev/setup
	@dev/test release

check:
	@dev/setup
	@dev/check

install:
	@dev/setup build
	@dev/build fast kadr kadr_files kadr_library
	cmake --install build/fast --prefix "$(PREFIX)"

deb:
	@dev/setup deb
	@dev/build fast kadr kadr_files
	cpack --config build/fast/CPackConfig.cmake -B build/deb
	lintian --fail-on error,warning --info build/deb/*.deb

dist:
	@dev/setup deb
	@dev/setup dist
	@dev/dist --chroot

vsix:
	@dev/vsix

web:
	@dev/setup build
	@dev/web

site:
	@dev/setup site
	@dev/site

clean:
	rm -rf build

.PHONY: all run test check install deb dist vsix web site clean
