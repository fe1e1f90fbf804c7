// Makes sure that scans are written to disk, even if their robot has been removed from the window.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include "core/mission/fleet/robot.h"
#include "core/mission/session/run_summary.h"

namespace usar::mission {

/// Asks robots for their records and writes them in a pool thread, one at a time. A removed robot with an unsaved scan
/// is kept here until its files are on disk. Belongs to the GUI thread; the destructor waits for the pool.
class ScanKeeper : public QObject {
    Q_OBJECT
public:
    explicit ScanKeeper(QObject* parent = nullptr);
    ~ScanKeeper() override;

    /// Sets the folder for results; empty: the default one. Unsaved scans of removed robots are tried again at once.
    void setFolder(const QString& folder);
    /// The folder in use: the chosen one, or else the default one.
    QString folder() const;
    bool folderChosen() const { return !folder_.isEmpty(); }

    /// Writes the robot's records from now on when they arrive, until the robot is destroyed. `truth` returns the
    /// simulator's figures for the summary, or nullopt; it is called in the GUI thread.
    void watch(Robot& robot, std::function<std::optional<TrueFigures>()> truth);
    /// Saves the current record of a watched robot; `saved` or `failed` follows.
    void save(Robot& robot);
    /// Takes over a removed robot: stops it, saves its scan if part of it is unsaved, then destroys it.
    void takeLeave(std::unique_ptr<Robot> robot);
    /// True while a record is awaited or being written, or the scan of a removed robot is not on disk.
    bool busy() const { return !awaited_.empty() || writing_ > 0 || !leaving_.empty(); }
    /// Tries again to save the scans of removed robots.
    void retry();
    /// Stops waiting for records that have not arrived, because their sessions hang.
    void giveUpWaiting();
    /// Destroys the removed robots that could not be saved.
    void forgetLeaving();

signals:
    /// `files` are full paths.
    void saved(int id, const QStringList& files);
    /// The scan is still in memory. `reason` names the folder and the remedy.
    void failed(int id, const QString& reason);

private:
    void write(Robot& robot, const std::shared_ptr<const ScanRecord>& record);
    void written(int id, const QPointer<Robot>& robot, const Result<QStringList>& files);
    /// True if the robot has been removed and is kept here.
    bool leaves(const Robot& robot) const;
    void release(Robot& robot);

    QThreadPool pool_;
    QString folder_; ///< empty: the default one
    std::map<const Robot*, std::function<std::optional<TrueFigures>()>> truths_;
    std::set<const Robot*> awaited_;              ///< robots whose record was requested and has not arrived
    std::vector<std::unique_ptr<Robot>> leaving_; ///< removed robots that are not saved yet
    int writing_ = 0;                             ///< number of records in the pool
};

} // namespace usar::mission
