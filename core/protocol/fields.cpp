#include "core/protocol/fields.h"
