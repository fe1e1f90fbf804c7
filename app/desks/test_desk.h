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

private:
    /// Opens the dialog for the moment that the selected robot shows.
    void begin();
    void read(const QString& path);
    void take(const Result<mission::FlightMoment>& moment);
    void offer();
    void write();
    void chooseFolder();
    QString folder() const;
    bool recorded() const;

    QPointer<widgets::TestDialog> dialog_;
    QString folder_;          ///< Empty: beside the results.
    QPointer<Robot> awaited_; ///< Its recording is being flushed.
    Seconds now_{0.0};        ///< The moment, on the protocol clock.
    std::optional<mission::FlightMoment> moment_;
    std::vector<mission::ClaimOffer> offers_;
    QThreadPool pool_;          ///< its destructor waits
};

} // namespace usar::app
