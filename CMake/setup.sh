# Sourced by ./demo, ./test and their like: packages, build, and an X server of one's own.
# shellcheck shell=bash
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

fail()
{
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# Installs what the given lists name and dpkg does not know as installed.
install_packages()
{
  command -v apt-get >/dev/null ||
    fail "this script is for Debian 12; elsewhere build with CMake as README.md says"
  local wanted missing=() installed package
  wanted=$(cd "$root" && sed 's/#.*//; s/[[:space:]]*$//; /^$/d' "$@")
  # shellcheck disable=SC2086 # one word a package
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
    sed -n 's/^installed //p') || true
  for package in $wanted; do
    grep -qxF "$package" <<<"$installed" || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then
    return
  fi

  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "run as root, or install: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# Configures build/ and builds the given targets. With WARNINGS_AS_ERRORS=ON in the environment, as
# continuous integration has it, a compiler warning is an error; another compiler than the project's may
# warn of nothing.
build_targets()
{
  # One set of options for all scripts, so that one reuses what the other has built.
  cmake -S "$root" -B "$build" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release \
    -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DSURFACEFLATTENING_WARNINGS_AS_ERRORS="${WARNINGS_AS_ERRORS:-OFF}" \
    -DSURFACEFLATTENING_LINT="${lint:-OFF}" \
    --log-level=WARNING
  cmake --build "$build" --target "$@"
}

# Starts an X server on a free display, exports DISPLAY, and ends the server when the script ends.
start_x_server()
{
  local display_file number='' tries
  display_file=$(mktemp)
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset \
    3>"$display_file" >"$build/Xvfb.log" 2>&1 &
  x_server=$!
  trap 'kill "$x_server" 2>/dev/null; wait "$x_server" 2>/dev/null || true' EXIT
  for ((tries = 0; tries < 300; ++tries)); do
    # read succeeds only on a whole line
    if read -r number <"$display_file"; then
      break
    fi
    kill -0 "$x_server" 2>/dev/null || fail "Xvfb ended: $(cat "$build/Xvfb.log")"
    sleep 0.05
  done
  rm -f "$display_file"
  [[ -n $number ]] || fail "Xvfb named no display in 15 s"
  unset XAUTHORITY
  export DISPLAY=":$number"
}
