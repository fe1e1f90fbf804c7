// What the file of a new recording is called.
#pragma once

#include <QDateTime>
#include <QString>

namespace usar::mission {

/// Path in `folder` of a file that is not there yet: "R1_2026-11-21_18-21-29.usarrec", or with a number behind it where
/// there is such a file. Signs of the robot's name that a file name had better not have become underscores.
QString newRecordingIn(const QString& folder, const QString& robot_name, const QDateTime& now);

} // namespace usar::mission
