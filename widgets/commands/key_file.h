// The keys that the user has changed, in a file.
#pragma once

#include <QObject>
#include <QThreadPool>

#include "core/base/result.h"
#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Gives the commands the keys of the file, and writes it with each change. The file is read in the calling thread, as
/// it is small, and written in one of a pool. GUI thread; the registry must outlive this object.
class KeyFile : public QObject {
    Q_OBJECT
public:
    /// The folder of `file` is made when the first key is changed.
    KeyFile(CommandRegistry& commands, QString file);
    /// Waits until the file is written.
    ~KeyFile() override { disk_.waitForDone(); }

    /// Reads the file; all commands must be registered. No file means that no key was ever changed. Emits `failed` if
    /// it cannot be understood; then all keys stay as they are.
    void read();

signals:
    /// The file cannot be understood or written.
    void failed(const usar::Error& error);

private:
    void write();

    CommandRegistry& commands_;
    QString file_;
    QThreadPool disk_; ///< of one thread, so that newer keys are written later
};

} // namespace usar::widgets
