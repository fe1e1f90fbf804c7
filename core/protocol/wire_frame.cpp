#include "core/protocol/wire_frame.h"
