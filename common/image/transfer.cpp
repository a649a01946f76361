// SPDX-License-Identifier: MIT
#include "image/transfer.h"

#include "transfer_curves.h"

namespace stagelight {

float encode(Transfer transfer, float light) {
    switch (transfer) {
    case Transfer::srgb:
        return transfer::srgb_encode(light);
    case Transfer::power:
        return transfer::power_encode(light);
    case Transfer::table:
        return transfer::table_encode(light);
    default:
        return transfer::within_screen(light);
    }
}

float decode(Transfer transfer, float value) {
    switch (transfer) {
    case Transfer::srgb:
    case Transfer::table:
        return transfer::srgb_decode(value);
    case Transfer::power:
        return transfer::power_decode(value);
    default:
        return value;
    }
}

}  // namespace stagelight
