// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef __OPTIMIZE__
#error "laws are compiled with optimization, whatever the host's flags are"
#endif
