#!/usr/bin/env bash
# Installs, through apt, what the build needs and is missing; with `tests`, what the tests need too; with `web`, what the
# page is built with, a part of it into build/web-tools. Nothing missing: nothing is asked, nothing is fetched.
set -euo pipefail

packages=(
    g++ cmake ninja-build pkg-config                  # the build
    libglm-dev nlohmann-json3-dev libcli11-dev        # header libraries
    libfmt-dev                                        # messages and numbers
    libspng-dev libjpeg-dev                           # picture files
    python3-glad libegl-dev libgl-dev libopengl-dev   # OpenGL: the loader's generator, headers
    libegl1 libgl1 libegl-mesa0 libgl1-mesa-dri       # OpenGL at run time, with a software renderer
    libglfw3-dev libimgui-dev fonts-dejavu-core       # the window
    help2man                                          # `cmake --install`: manual pages
)
tests=(libgtest-dev libbenchmark-dev libstb-dev xvfb xdotool imagemagick procps
       dpkg-dev file desktop-file-utils bash-completion) # and what packs the program

web=(clang-19 lld-19 llvm-19 python3 nodejs node-acorn dpkg-dev # Emscripten runs on these
     python3-fonttools fonts-droid-fallback)                   # the page's fonts
web_tests=(chromium brotli)

fail() {
    echo "install.sh: $*" >&2
    exit 1
}

with() { [[ " $words " == *" $1 "* ]]; }
words=$*
for word in "$@"; do
    case $word in
    tests) packages+=("${tests[@]}") ;;
    web) packages+=("${web[@]}") ;;
    *) fail "expected nothing, 'tests' or 'web', got '$word'" ;;
    esac
done
if with tests && with web; then
    packages+=("${web_tests[@]}")
    command -v npm >/dev/null || packages+=(npm) # a newer Node.js brings its own
fi
# Debian 12 has an Emscripten that is too old: web_tools.sh fetches another.
if with web && (source /etc/os-release && [[ $ID == debian && ${VERSION_ID:-99} -ge 13 ]]) 2>/dev/null; then
    packages+=(emscripten)
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this machine has no apt (Debian, Ubuntu). Install these, or what your system calls them, then run" \
        "'cmake --preset release && cmake --build --preset release': ${packages[*]}"
fi

install_packages() {
    local as_root=() apt
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null || fail "needs root or sudo to install: $*"
        as_root=(sudo)
    fi
    apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -qq)
    echo "Installing $*" >&2
    "${apt[@]}" update >/dev/null || fail "apt-get update failed; is there a network, and are its sources right?"
    "${apt[@]}" install --yes --no-remove --no-install-recommends "$@" >/dev/null || fail "apt-get could not install: $*"
}

installed=$(dpkg-query -W -f='${db:Status-Status}:${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
    [[ $'\n'$installed$'\n' == *$'\n'"installed:$package"$'\n'* ]] || missing+=("$package")
done
if [[ ${#missing[@]} -gt 0 ]]; then
    install_packages "${missing[@]}"
fi
if with web; then
    "$(dirname "${BASH_SOURCE[0]}")/web_tools.sh" "$(dirname "${BASH_SOURCE[0]}")/../build/web-tools"
fi
