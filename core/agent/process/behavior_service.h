// The counterpart of IsolatedBehavior and IsolatedPlugin, which runs in usar-behavior-host.
#pragma once

namespace usar::agent {

/// Loads the plugin named by the first frame, creates the behavior, and answers requests until the connection ends. If
/// a signal is about to end the process, it first sends the number of the signal. Returns the exit code. Ends the
/// process at once if the other side disappears, whatever the behavior is doing. Owns and closes `socket`.
int serveBehavior(int socket);

} // namespace usar::agent
