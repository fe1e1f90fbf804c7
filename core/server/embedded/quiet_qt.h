// Qt's warnings that help nobody.
#pragma once

namespace usar::server {

/// Keeps Qt from warning that XDG_RUNTIME_DIR is not set, as it is for root, in containers and over ssh: Qt then uses a
/// folder of its own, and the programs need none. Other messages come as before. Call it first in `main`.
void keepQtQuiet();

} // namespace usar::server
