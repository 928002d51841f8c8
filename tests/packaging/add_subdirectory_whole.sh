#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
WHOLE=yes exec bash "$(dirname "$0")/add_subdirectory.sh"
