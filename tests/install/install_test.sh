#!/usr/bin/env bash
# install_test.sh BUILD: what `cmake --install` places, and the Debian package, hold what they should and nothing else.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
    echo "install_test: $*" >&2
    exit 1
}
# expect TEXT PATTERN WHAT
expect() {
    [[ $1 =~ $2 ]] || fail "$3: expected '$2' in: $1"
}

# cmake --install: the program, its menu entry, icons, completion, licences, manual.
cmake --install "$build" --prefix "$folder/usr" >/dev/null
program=$folder/usr/bin/shading-sandbox
share=$folder/usr/share
commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
wanted=(bin/shading-sandbox share/applications/shading-sandbox.desktop
    share/bash-completion/completions/shading-sandbox share/doc/shading-sandbox/copyright)
for size in 48 128 256; do
    wanted+=("share/icons/hicolor/${size}x$size/apps/shading-sandbox.png")
done
if command -v help2man >/dev/null; then
    wanted+=(share/man/man1/shading-sandbox.1.gz)
    for command in $commands; do
        wanted+=("share/man/man1/shading-sandbox-$command.1.gz")
    done
fi
diff <(printf '%s\n' "${wanted[@]}" | sort) <(cd "$folder/usr" && find . -type f -printf '%P\n' | sort) ||
    fail "other files than expected (<) were installed (>)"
expect "$(cd / && "$program" --version)" '^shading-sandbox [0-9]' "the installed program, from another folder"
expect "$(cd / && "$program" glsl studio --technique per-pixel/phong)" '#version 330' "the installed program's assets"
if command -v desktop-file-validate >/dev/null; then
    desktop-file-validate --no-hints "$share/applications/shading-sandbox.desktop"
fi
if command -v help2man >/dev/null; then
    expect "$(zcat "$share/man/man1/shading-sandbox-capture.1.gz")" 'wireframe' "the manual of capture"
fi

# Completion, as bash asks for it.
if [[ -f /usr/share/bash-completion/bash_completion ]]; then
    complete_line() {
        PATH=$folder/usr/bin:$PATH bash -c '
            set +u
            source /usr/share/bash-completion/bash_completion
            source "$0"
            COMP_LINE="$*" COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMP_POINT=${#COMP_LINE}
            _shading_sandbox "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
            printf "%s " "${COMPREPLY[@]}"' "$share/bash-completion/completions/shading-sandbox" "$@"
    }
    cd "$folder"
    expect "$(complete_line shading-sandbox cap)" '^capture ' "a command"
    expect "$(complete_line shading-sandbox capture three-p)" 'three-point-lights' "a scene"
    expect "$(complete_line shading-sandbox capture studio --wiref)" '^--wireframe ' "an option of a command"
    expect "$(complete_line shading-sandbox capture studio --technique per-pixel/bl)" '^per-pixel/blinn-phong ' "a technique"
    expect "$(complete_line shading-sandbox capture studio --profile e)" '^es ' "a profile"
    expect "$(complete_line shading-sandbox lesson vertex)" 'vertex-or-pixel' "a lesson"
    expect "$(complete_line shading-sandbox mark lam)" 'lambert' "an exercise"
    expect "$(complete_line shading-sandbox stability --case exponent-0)" 'exponent-0-phong' "a stability case"
    cd - >/dev/null
fi

# The package.
if ! command -v dpkg-shlibdeps >/dev/null; then
    echo "no dpkg-shlibdeps here: the Debian package is not built"
    exit 0
fi
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$folder/package" >"$folder/cpack.log" 2>&1 ||
    fail "cpack: $(cat "$folder/cpack.log")"
package=$(echo "$folder"/package/*.deb)
size=$(stat -c %s "$package")
((size <= 6000000)) || fail "the package has $size bytes, expected at most 6,000,000"
expect "$(dpkg-deb --field "$package" Depends)" 'libc6.*libegl1|libegl1.*libc6' "what the package depends on"
expect "$(dpkg-deb --field "$package" Recommends)" '^libglfw3' "what the window needs"
dpkg-deb --extract "$package" "$folder/root"
expect "$("$folder/root/usr/bin/shading-sandbox" --version)" '^shading-sandbox [0-9]' "the packed program"
echo "installed $(find "$folder/usr" -type f | wc -l) files; $(basename "$package"): $size bytes"
if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning "$package" # --allow-root: build machines are root
fi
