/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Feeds arbitrary bytes to the line interpreter, as a stream in a safe session. See 'make fuzz'. */
#include "session.h"
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 0)
        fuzz_session(data, size, true);
    return 0;
}
