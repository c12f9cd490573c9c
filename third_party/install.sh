#!/usr/bin/env bash
# Installs, through apt, what the build needs and is missing; with `tests`, what the tests need too.
# Nothing missing: nothing is asked, nothing is fetched.
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

fail() {
    echo "install.sh: $*" >&2
    exit 1
}

case "${1:-}" in
'') ;;
tests) packages+=("${tests[@]}") ;;
*) fail "expected nothing or 'tests', got '$1'" ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this machine has no apt (Debian, Ubuntu). Install these, or what your system calls them, then run" \
        "'cmake --preset release && cmake --build --preset release': ${packages[*]}"
fi

installed=$(dpkg-query -W -f='${db:Status-Status}:${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
    [[ $'\n'$installed$'\n' == *$'\n'"installed:$package"$'\n'* ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null || fail "needs root or sudo to install: ${missing[*]}"
    as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -qq)
echo "Installing ${missing[*]}" >&2
"${apt[@]}" update >/dev/null || fail "apt-get update failed; is there a network, and are its sources right?"
"${apt[@]}" install --yes --no-remove --no-install-recommends "${missing[@]}" >/dev/null || fail "apt-get could not install: ${missing[*]}"
