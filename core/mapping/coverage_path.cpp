#include "core/mapping/coverage_path.h"
