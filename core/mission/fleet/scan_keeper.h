// Sees to it that what was scanned reaches the disk, also when its robot is gone from the window.
#pragma once

#include <functional>
#include <map>
#include <memory>
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

/// Asks robots for their records and writes them in a pool, one at a time. A robot that leaves with an unsaved scan is
/// kept here until its files lie on the disk. GUI thread; waits for the pool at its end.
class ScanKeeper : public QObject {
    Q_OBJECT
public:
    explicit ScanKeeper(QObject* parent = nullptr);
    ~ScanKeeper() override;

    /// Empty: the default one. Scans of robots that have left are tried again at once.
    void setFolder(const QString& folder);
    QString folder() const;
    bool folderChosen() const { return !folder_.isEmpty(); }

    /// From now on the robot's records are written when they come. `facts` is asked for each of them.
    void watch(Robot& robot, std::function<SimulatorFacts()> facts);
    /// The record as it stands now; `saved` or `failed` follows.
    void save(Robot& robot);
    /// Stops it, saves it where there is something to save, and lets it go.
    void takeLeave(std::unique_ptr<Robot> robot);
    /// A record is asked for or being written, or the scan of a robot that has left is not on the disk.
    bool busy() const { return !awaited_.empty() || writing_ > 0 || !leaving_.empty(); }
    /// Tries scans of robots that have left once more.
    void retry();
    /// Stops waiting for records that never came: their sessions hang.
    void giveUpWaiting();

signals:
    void saved(int id, const QStringList& files);
    /// The scan is still in memory; `reason` names the folder and the mend.
    void failed(int id, const QString& reason);

private:
    void write(Robot& robot, const std::shared_ptr<const ScanRecord>& record);
    void written(int id, const QPointer<Robot>& robot, const Result<QStringList>& files);
    bool leaves(const Robot& robot) const;
    void release(Robot& robot);

    QThreadPool pool_;
    QString folder_;
    std::map<const Robot*, std::function<SimulatorFacts()>> facts_;
    std::set<const Robot*> awaited_;
    std::vector<std::unique_ptr<Robot>> leaving_;
    int writing_ = 0;
};

} // namespace usar::mission
