// A campaign that is flown by `usar-mission` beside a program that has other things to do, such as the window.
#pragma once

#include <QObject>
#include <QProcess>

#include "core/base/result.h"

namespace usar::campaign {

/// Starts `usar-mission campaign` and tells how it ended. The results are in the folder, where ResultTail follows them.
/// The process ends with this object, and also if this program dies; results that are written stay. Lives in its
/// owner's thread, which needs an event loop and is never blocked but by the destructor.
class CampaignProcess : public QObject {
    Q_OBJECT
public:
    explicit CampaignProcess(QObject* parent = nullptr);
    ~CampaignProcess() override;

    /// Flies what is missing of the campaign. `program`: path of usar-mission; `jobs`: missions at a time. `ended`
    /// follows, also if the program cannot be started.
    void start(const QString& program, const QString& file, const QString& folder, int jobs);
    /// Ends it in an orderly way; missions under way are given up, and `ended` follows.
    void stop();
    bool running() const { return process_.state() != QProcess::NotRunning; }
    qint64 processId() const { return process_.processId(); }

signals:
    /// `trouble` is a sentence about why the campaign could not be flown, or stopped by itself; empty if all was well,
    /// or if it was stopped on request.
    void ended(const QString& trouble);

private:
    QString troubleOf(int exit_code, QProcess::ExitStatus status);

    QProcess process_;
    bool stopped_ = false; ///< Somebody has asked for the end.
};

} // namespace usar::campaign
