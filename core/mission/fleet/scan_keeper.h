// Makes sure that scans are written to disk, even after their robot was removed from the window.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>

#include "core/mapping/height_look.h"
#include "core/mission/files/map_formats.h"
#include "core/mission/fleet/robot.h"
#include "core/mission/runs/run_summary.h"

namespace usar::mission {

/// Asks robots for their records and writes them in a thread pool, one at a time. A robot that leaves with an unsaved
/// scan is kept here until its files are on disk. Belongs to the GUI thread; the destructor waits for the pool.
class ScanKeeper : public QObject {
    Q_OBJECT
public:
    ScanKeeper() { pool_.setMaxThreadCount(1); }
    ~ScanKeeper() override { pool_.waitForDone(); }

    /// Sets the result folder; empty means the default one. Retries scans of robots that have left at once.
    void setFolder(const QString& folder);
    QString folder() const;
    /// Look of the pictures that are written from now on; initially in color over the whole range.
    void setPictureLook(const mapping::HeightLook& look) { look_ = look; }
    bool folderChosen() const { return !folder_.isEmpty(); }

    /// Writes the robot's records from now on, whenever they arrive. `facts` is called for each of them.
    void watch(Robot& robot, std::function<SimulatorFacts()> facts);
    /// Saves the current record; `saved` or `failed` follows.
    void save(Robot& robot);
    /// Exports the robot's map of this moment, see mission::exportMap; `exported` or `exportRefused` follows.
    void exportMap(Robot& robot, const FormatList& formats, const QString& folder);
    /// Stops the robot, saves its scan if there is anything to save, and then deletes the robot.
    void takeLeave(std::unique_ptr<Robot> robot);
    /// True while a record is requested or being written, or the scan of a robot that has left is not on disk.
    bool busy() const { return !awaited_.empty() || !exports_.empty() || writing_ > 0 || !leaving_.empty(); }
    /// Gives up writing; nothing of it stays on disk. `cancelled` follows for each record that is not yet complete.
    void cancel();
    /// Retries saving the scans of robots that have left.
    void retry();
    /// Stops waiting for requested records, because their sessions hang.
    void giveUpWaiting();

signals:
    /// `summary` is complete, with the full paths of the files. The robot may be gone from the window, so that only
    /// `robot_name` tells who it was.
    void saved(usar::RobotId id, const usar::mission::RunSummary& summary, const QString& robot_name);
    /// The scan is still in memory; `reason` names the folder and a remedy.
    void failed(usar::RobotId id, const QString& reason);
    /// As `failed`, but because the user wanted it.
    void cancelled(usar::RobotId id, const QString& reason);
    void exported(const QStringList& files, const QString& robot_name);
    void exportRefused(const QString& reason, bool cancelled);
    /// The record of this robot is being written now; empty: none is.
    void writingChanged(const QString& robot_name);

private:
    /// Whose record is being written.
    struct Writing {
        RobotId id;
        QString robot_name;
        QPointer<Robot> robot; ///< null once it is deleted
        std::stop_token stop;
    };

    /// A map that was requested for an export.
    struct MapExport {
        FormatList formats;
        QString folder;
    };

    void write(Robot& robot, const std::shared_ptr<const ScanRecord>& record);
    void writeMap(Robot& robot, const std::shared_ptr<const ScanRecord>& record);
    void mapWritten(const Result<QStringList>& files, const QString& robot_name, bool cancelled);
    /// Maps that were requested from a robot that is gone are refused.
    void dropExports(const Robot* robot);
    void written(const Writing& writing, const Result<RunSummary>& summary);
    /// Deletes a robot that has left; returns false for one that has not.
    bool release(const Robot& robot);

    QThreadPool pool_;
    QString folder_;
    mapping::HeightLook look_;
    std::map<const Robot*, std::function<SimulatorFacts()>> facts_;
    std::set<const Robot*> awaited_;                 ///< robots whose record was requested and has not arrived
    std::vector<std::unique_ptr<Robot>> leaving_;    ///< removed robots that are kept until they are saved
    std::multimap<const Robot*, MapExport> exports_; ///< maps that were requested and have not arrived
    int writing_ = 0;                                ///< number of records being written
    std::stop_source stop_;                          ///< stops the saves that run
};

} // namespace usar::mission
