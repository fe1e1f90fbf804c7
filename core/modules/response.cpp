#include "core/modules/response.h"
