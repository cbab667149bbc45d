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

# Runs apt-get with the given arguments, as root. Another program may be installing packages, as a new
# machine does by itself: apt-get waits for dpkg's locks if told to, but not for that of the lists.
apt_get()
{
  local as_root=() said tries
  if ((EUID != 0)); then
    as_root=(sudo)
  fi
  said=$(mktemp)
  for ((tries = 0; tries < 120; ++tries)); do
    if "${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
      apt-get -q -o DPkg::Lock::Timeout=600 "$@" 2>"$said"; then
      cat "$said" >&2
      rm -f "$said"
      return
    fi
    cat "$said" >&2
    grep -q 'Could not get lock' "$said" || break
    echo "Waiting for the program that holds apt's lock" >&2
    sleep "${APT_PAUSE:-5}"
  done
  rm -f "$said"
  return 1
}

# Prints those of the given packages that can be installed; fails where there is none.
apt_knows()
{
  local package known=1
  for package in "$@"; do
    if apt-cache show "$package" >/dev/null 2>&1; then
      echo "$package"
      known=0
    fi
  done
  return "$known"
}

# Prints those packages of the given lists that dpkg knows as installed.
installed_packages()
{
  # shellcheck disable=SC2046 # one word a package
  (cd "$root" && dpkg-query -W -f='${db:Status-Status} ${Package}\n' $(packages_of "$@") 2>/dev/null) |
    sed -n 's/^installed //p' || true
}

packages_of()
{
  (cd "$root" && sed 's/#.*//; s/[[:space:]]*$//; s/^?//; /^$/d' "$@")
}

# Installs what the given lists name and dpkg does not know as installed.
install_packages()
{
  command -v apt-get >/dev/null ||
    fail "this script is for Debian; elsewhere build with CMake as README.md says"
  # A package with a question mark is installed where there is one of that name.
  local wanted missing=() maybe=() installed package
  wanted=$(cd "$root" && sed 's/#.*//; s/[[:space:]]*$//; /^$/d' "$@")
  installed=$(installed_packages "$@")
  for package in $wanted; do
    if grep -qxF "${package#\?}" <<<"$installed"; then
      continue
    elif [[ $package == \?* ]]; then
      maybe+=("${package#\?}")
    else
      missing+=("$package")
    fi
  done
  if ((${#missing[@]} == 0)) && ! apt_knows "${maybe[@]}" >/dev/null; then
    return
  fi

  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "run as root, or install: ${missing[*]}"
  fi
  echo "Installing ${missing[*]} ${maybe[*]}"
  apt_get update
  # shellcheck disable=SC2207 # one word a package
  missing+=($(apt_knows "${maybe[@]}")) || true
  apt_get install -y --no-install-recommends "${missing[@]}"
}

# Configures build/ and builds the given targets. With WARNINGS_AS_ERRORS=ON in the environment, as
# continuous integration has it, a compiler warning is an error; another compiler than the project's may
# warn of nothing. With others=OFF tests and the Python package, whose packages ./demo does not install, are left out.
build_targets()
{
  # One set of options for all scripts, so that one reuses what the other has built.
  cmake -S "$root" -B "$build" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release \
    -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DSURFACEFLATTENING_WARNINGS_AS_ERRORS="${WARNINGS_AS_ERRORS:-OFF}" \
    -DSURFACEFLATTENING_LINT="${lint:-OFF}" \
    -DBUILD_TESTING="${others:-ON}" \
    -DSURFACEFLATTENING_WRAP_PYTHON="${others:-ON}" \
    -DSURFACEFLATTENING_PRECOMPILE_HEADERS=ON \
    -DSURFACEFLATTENING_UNITE_SOURCES=ON \
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
