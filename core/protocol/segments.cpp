#include "core/protocol/segments.h"
