// The file name of a new recording.
#pragma once

#include <QDateTime>
#include <QString>

namespace usar::mission {

/// Returns the path in `folder` of a file that does not exist yet: "R1_2026-11-21_18-21-29.usarrec", with a number
/// appended to the name if that file exists. Characters of the robot's name that are unsafe in a file name become
/// underscores.
QString newRecordingIn(const QString& folder, const QString& robot_name, const QDateTime& now);

} // namespace usar::mission
