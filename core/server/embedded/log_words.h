// Decides which lines of the embedded simulator's log the window shows as notices.
#pragma once

#include <QString>

namespace usar::server {

/// The sentence without the number of the connection, which means nothing in the window: "Simulator: ignored 'HORN'".
/// Empty for what the window's own views say better: that connections come and go.
QString noticeOfLog(const QString& logged);

} // namespace usar::server
