// Desk for tests that are made of moments of flights.
#pragma once

#include <optional>

#include <QPointer>
#include <QThreadPool>

#include "app/desks/desk.h"
#include "core/mission/runs/flight_moment.h"
#include "widgets/panels/test_dialog.h"

namespace usar::app {

/// Reads the recording of the selected robot, live or replayed, and writes a mission with a claim, which `usar-mission
/// campaign --tests` flies. The recording is read in a pool. GUI thread.
class TestDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override { folder_ = settings.value("test_folder").toString(); }
    void save(SettingsSheet& settings) const override { settings.setValue("test_folder", folder_); }

    ~TestDesk() override { giveUp(); }

private:
    /// Drops the request that is under way, because nobody waits for its answer any longer.
    void giveUp();
    void makeDialog();
    /// Opens the dialog for the moment that the selected robot shows.
    void begin();
    /// Reads the recording in the pool; does nothing if a newer request than this one has come.
    void read(int request, const QString& path);
    void take(const Result<mission::FlightMoment>& moment);
    void offer();
    void show();
    void setHeight(double height_m);
    void write();
    void chooseFolder();
    QString folder() const;
    bool recorded() const;

    QPointer<widgets::TestDialog> dialog_;
    QString folder_;                 ///< It is empty if tests go beside the results.
    int request_ = 0;                ///< number of the newest one
    QString robot_name_;             ///< The newest request is about this robot.
    Seconds now_{0.0};               ///< It is about this moment, on the protocol clock.
    QMetaObject::Connection gone_{}; ///< tells if that robot leaves
    std::shared_ptr<std::atomic_bool> given_up_ = std::make_shared<std::atomic_bool>(false); ///< stops the reading
    std::optional<mission::FlightMoment> moment_;
    std::vector<mission::Claim> offers_; ///< in the order of the dialog's list
    QThreadPool pool_;                   ///< reads recordings; the last member, so that it ends first
};

} // namespace usar::app
