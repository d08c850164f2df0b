# A thin door to the scripts of dev/.
.POSIX:
PREFIX = /usr/local
EXAMPLE = examples/s2c42/flange
PICTURE = out/flange.svg

all:
	@dev/build release

run:
	@dev/setup build
	@dev/build release kadr
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
	@dev/build release kadr
	install -D -m 755 build/release/kadr "$(DESTDIR)$(PREFIX)/bin/kadr"
	build/release/kadr man >build/release/kadr.1
	install -D -m 644 build/release/kadr.1 "$(DESTDIR)$(PREFIX)/share/man/man1/kadr.1"
	build/release/kadr completion bash >build/release/kadr.bash
	install -D -m 644 build/release/kadr.bash "$(DESTDIR)$(PREFIX)/share/bash-completion/completions/kadr"

clean:
	rm -rf build

.PHONY: all run test check install clean
