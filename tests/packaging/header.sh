#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Doxygen reads the public header without a warning: every member of it is documented.
source "$(dirname "$0")/support.sh"

need doxygen
cd "$work"
cat >Doxyfile <<END
PROJECT_NAME = sonde
INPUT = $BUILD/include/sonde/sonde.hpp
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
EXTRACT_ALL = NO
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = NO
WARN_LOGFILE = warnings
QUIET = YES
END
doxygen Doxyfile >/dev/null
[[ ! -s warnings ]] || complain "$(cat warnings)"
grep -q '<name>separate</name>' xml/namespacesonde.xml || complain "doxygen saw no function"
