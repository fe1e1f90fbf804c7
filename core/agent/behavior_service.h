// The other side of IsolatedBehavior: the work of usar-behavior-host.
#pragma once

namespace usar::agent {

/// Loads the plugin that the first frame names, makes the behavior, and answers until the connection ends. Before a
/// signal ends the process it says which one. Returns the exit code; ends the process at once where the other side is
/// gone, whatever the behavior is doing.
int serveBehavior(int socket);

} // namespace usar::agent
