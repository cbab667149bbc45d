# shellcheck shell=sh
# ParaView's menu Macros shows what lies in a folder of the user's. What the user deletes there, ParaView keeps
# as a hidden file: such a macro does not come back.
link_macro()
{
  macros=${XDG_CONFIG_HOME:-$HOME/.config}/ParaView/Macros
  for known in "$macros/$(basename "$1")" "$macros/.$(basename "$1" .py)"*; do
    if [ -e "$known" ]; then
      return
    fi
  done
  # Without a folder to write to ParaView starts all the same.
  mkdir -p "$macros" 2>/dev/null && ln -sf "$1" "$macros/" 2>/dev/null
}
