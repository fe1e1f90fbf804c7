// Desk for recording and replay: commands, the replay bar above the map, and the badge of the recording.
#pragma once

#include <vector>

#include "app/desks/desk.h"

namespace usar::app {

/// Switches recording on and off for all robots, and controls the selected replay. GUI thread.
class ReplayDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

    /// These replays show the same time from now on: an order to one of them is given to all.
    void keepTogether(const std::vector<RobotId>& replays);

signals:
    /// The user wants to replay this recording.
    void recordingChosen(const QString& path);

private:
    /// Updates the bar and the badge for the selected robot.
    void show();
    /// Sends an order to the selected replay, and to those that show the same time; has no effect on a live robot.
    void order(const mission::ReplayOrder& order);
    void setRecording(bool on);
    void askForLimit();
    /// 0: recordings have no limit.
    void setLimit(int limit_mb);
    /// Puts on the clipboard how to open the selected replay at this moment, as words for a shell.
    void copyLink();

    int limit_mb_ = 0;              ///< The limit of each recording; with 0 there is none.
    std::vector<RobotId> together_; ///< replays that show the same time
};

} // namespace usar::app
