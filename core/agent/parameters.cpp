#include "core/agent/parameters.h"
