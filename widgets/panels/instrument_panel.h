// The dock of the instruments: those that the selected robot has, and no others.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include "widgets/models/robot_instruments.h"
#include "widgets/panels/attitude_view.h"
#include "widgets/panels/instruments.h"
#include "widgets/panels/reading_list_view.h"
#include "widgets/panels/sonar_ring_view.h"
#include "widgets/panels/status_strip.h"

namespace usar::widgets {

/// Instruments come and go with what the robot tells of. Each turns gray with its age when its own sensor is silent,
/// and all do when the robot is. Without any instrument a sentence says why. GUI thread.
class InstrumentPanel : public QWidget {
    Q_OBJECT
public:
    explicit InstrumentPanel(QWidget* parent = nullptr);

    /// Shows what this robot has said until `now` (protocol clock); only changes are painted. `linked`: false while it
    /// is silent as a whole. `judged` are the sonars with their risks as a running behavior sees them; nullptr: none
    /// does.
    void showRobot(const RobotInstruments& robot, Seconds now, bool linked, const agent::SonarZones* judged = nullptr);
    /// Shows no instrument, because no robot is selected.
    void clear();

    StatusStrip* status() const { return status_; }
    LaserFanView* laser() const { return laser_; }
    /// Its owner shows or hides it, because the robot's map is no sensor.
    TerrainProfileView* terrain() const { return terrain_; }
    SonarColumnsView* sonars() const { return sonars_; }
    AttitudeView* attitude() const { return attitude_; }
    SonarRingView* ring() const { return ring_; }
    /// The lists that are shown, in their order.
    std::vector<const ReadingListView*> lists() const;
    /// Captions of the figures that are shown, in their order.
    QStringList figures() const;
    /// The sentence that says why there is no instrument; empty if there is one.
    QString emptyWords() const { return empty_->isHidden() ? QString() : empty_->text(); }

private:
    void showAttitude(const RobotInstruments& robot, Seconds now, bool linked);
    void showFigures(const RobotInstruments& robot, Seconds now, bool linked);
    void showRanges(const RobotInstruments& robot, Seconds now, bool linked, const agent::SonarZones* judged);
    void showLists(const RobotInstruments& robot, Seconds now, bool linked);
    void showWords(const RobotInstruments& robot, Seconds now);
    /// The readout with this caption, made if there is none.
    Readout* readout(const InstrumentFigure& figure);

    StatusStrip* status_ = new StatusStrip(this);
    QLabel* empty_ = new QLabel(this);
    AttitudeView* attitude_ = new AttitudeView(this);
    QGridLayout* figure_grid_ = new QGridLayout;
    std::map<QString, Readout*> readouts_; ///< by caption
    QStringList shown_figures_;
    std::pair<const void*, Seconds> shown_scan_{}; ///< whose scan is shown, and of when
    LaserFanView* laser_ = new LaserFanView(this);
    TerrainProfileView* terrain_ = new TerrainProfileView(this);
    SonarRingView* ring_ = new SonarRingView(this);
    SonarColumnsView* sonars_ = new SonarColumnsView(this);
    QVBoxLayout* list_column_;
    std::vector<ReadingListView*> lists_; ///< those beyond the robot's lists are hidden
};

} // namespace usar::widgets
