#include "core/link/simulator_server.h"
