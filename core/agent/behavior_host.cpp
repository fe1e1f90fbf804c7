#include "core/agent/behavior_host.h"
