#include "core/modules/query.h"
