// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::ui {

/// From here on the process gives freed memory back to the system as soon as a mebibyte of it lies
/// together. By itself the C library keeps blocks of up to 32 MiB once one of that size was freed:
/// what reading a large mesh takes for a second would stay taken. And it gives threads heaps of
/// their own, up to eight a processor: what their short blocks leave there grows with every scene
/// that is opened. Here they share two. It costs the threads that
/// allocate some page faults; the servo does not allocate. Where the C library is not GNU's,
/// nothing happens.
void return_freed_memory();

}  // namespace sonde::ui
