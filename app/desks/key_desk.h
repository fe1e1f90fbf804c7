// The keys that the user has changed, in a file beside the settings.
#pragma once

#include <QDialog>
#include <QPointer>
#include <QThreadPool>

#include "app/desks/desk.h"

namespace usar::app {

/// Opens the sheet of keys, and keeps what is changed there in keys.json. Owned by ViewDesk. GUI thread.
class KeyDesk : public Desk {
    Q_OBJECT
public:
    explicit KeyDesk(const DeskContext& context);

    /// Opens the sheet; there is never a second one.
    void registerCommands() override;
    /// Reads the file; all commands must be registered.
    void wire() override;

private:
    void read();
    void write();

    QString file_;
    QPointer<QDialog> sheet_; ///< nullptr while it is closed
    QThreadPool disk_;        ///< of one thread; its destructor waits until the file is written
};

} // namespace usar::app
