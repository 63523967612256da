/* fuzz_number.c -- texts as rationals: what is read is written so that it is read as the same number again; where the written number is
 * long, of one in 64. */
#include "proofs-tests/fuzz/file.h"

#include "exact/number/rational.h"
#include "exact/number/region.h"
#include "exact/words.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 4096)
        return -1;
    char text[4097];
    memcpy(text, data, size);
    text[size] = '\0';
    region_faults = 0;
    region_mark mark = region_open();
    num_q a = from_string_q(text);
    if (region_faults == 0) {
        const char *written = to_string_q(a); /* which may have more digits than are read */
        size_t length = strlen(written);
        if (length < 100000 && (length < 200 || is_one_of_64(data, size)) && !cagd_equal_q(from_string_q(written), a))
            abort();
    } else if (region_faults != FAULT_UNDEFINED && region_faults != FAULT_UNABLE) {
        abort();
    }
    region_drop(mark);
    return 0;
}
