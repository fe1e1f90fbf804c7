#include "core/link/tcp_link.h"
