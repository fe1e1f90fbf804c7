// Desk for recording and replay: commands, the replay bar above the map, and the badge of the recording.
#pragma once

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"

namespace usar::app {

/// Switches recording on and off for all robots, and controls the selected replay. GUI thread.
class ReplayDesk : public QObject {
    Q_OBJECT
public:
    explicit ReplayDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    /// Updates the bar and the badge for the selected robot.
    void show();
    /// Sends an order to the selected replay; has no effect on a live robot.
    void order(const mission::ReplayOrder& order);
    void setRecording(bool on);
    /// Lets the user choose a recording and opens it as a replay.
    void chooseRecording();

    DeskContext desk_;
};

} // namespace usar::app
