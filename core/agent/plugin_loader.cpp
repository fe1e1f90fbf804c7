#include "core/agent/plugin_loader.h"
