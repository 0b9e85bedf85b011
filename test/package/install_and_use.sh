#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs a build into a folder of its own, runs what is installed and builds a foreign filter
# against it: install_and_use.sh CMAKE BUILD_FOLDER
source "$(dirname "$0")/../../scripts/environment.sh"
cmake=$1 build=$2
work=$(mktemp -d)  # not below the sources, where roslaunch would find every launch file twice
trap 'rm -rf "$work"' EXIT

DESTDIR=$work "$cmake" --install "$build" > "$work/log"
installed=$(dirname "$(find "$work" -path '*/share/adaptive_localization' -type d)")/..
for file in share/adaptive_localization/{config/filters/kld.yaml,config/rviz_plugins.xml,launch/demo.launch,maps/maze/map.pgm} \
  include/adaptive_localization/filters/filter.hpp; do
  if [ ! -f "$installed/$file" ]; then echo "not installed: $file" && exit 1; fi
done
if [ -f "$build/devel/lib/libadaptive_localization_rviz.so" ]; then  # where its description says
  panel=$(sed -n 's/.*library path="\([^"]*\)".*/\1/p' "$installed/share/adaptive_localization/config/rviz_plugins.xml")
  file=share/adaptive_localization/$panel.so
  if [ ! -f "$installed/$file" ]; then echo "not installed: $file" && exit 1; fi
fi
env -u LD_LIBRARY_PATH "$installed/lib/adaptive_localization/list_options" > "$work/options"
grep -q kld_err "$work/options"
env -u LD_LIBRARY_PATH "$installed/lib/adaptive_localization/replay" --help > /dev/null

"$cmake" -S "$(dirname "$0")" -B "$work/foreign" "-DCMAKE_PREFIX_PATH=$installed;${CMAKE_PREFIX_PATH:-}"
"$cmake" --build "$work/foreign"
{ "$work/foreign/01_track_log" 2>&1 || true; } | grep -q "usage: 01_track_log"
