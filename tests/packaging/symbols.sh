#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The shared library shows the functions of the public header and nothing else, and its soname is that
# of the face: below 1.0 each minor version may have another one, from then on each major one.
source "$(dirname "$0")/support.sh"

library=$PREFIX/$LIBDIR/libsonde.so.$VERSION
face=${VERSION%%.*}
if [[ $face == 0 ]]; then face=${VERSION%.*}; fi
readelf -d "$library" | grep -qF "[libsonde.so.$face]" || complain "soname"
nm -DC --defined-only "$library" | cut -d' ' -f3- |
  sed -E 's/\(.*//; s/\[abi:[^]]*\]//g' | sort -u >"$work/shown"
sort -u >"$work/expected" <<'END'
sonde::Follower::Follower
sonde::Follower::follow
sonde::Follower::last
sonde::Follower::operator=
sonde::Follower::start
sonde::Follower::time_phases
sonde::Follower::~Follower
sonde::Pair::Pair
sonde::Pair::exchanged
sonde::distance
sonde::facts
sonde::fingerprint
sonde::inside
sonde::make_body
sonde::nearest_point
sonde::offset_body
sonde::part_at
sonde::pose_of_matrix
sonde::principal_stiffnesses
sonde::ray
sonde::read_body
sonde::read_pair
sonde::seed_of_pose
sonde::separate
sonde::separate_about
sonde::separate_along
sonde::separate_in_plane
sonde::signed_distance
sonde::sweep
sonde::touch
sonde::triangles
sonde::vertices
sonde::with_mass
sonde::wrench
sonde::wrench_derivative
sonde::write_pair
END
diff "$work/expected" "$work/shown"
# Each only as the header declares it; constructors and destructors have two names each.
same_output 46 sh -c "nm -D --defined-only '$library' | wc -l"
