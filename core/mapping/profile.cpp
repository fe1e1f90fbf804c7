#include "core/mapping/profile.h"
