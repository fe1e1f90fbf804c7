#include "core/modules/state.h"
