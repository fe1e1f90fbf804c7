#include "app/desks/key_desk.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/hand_over.h"
#include "widgets/commands/key_map.h"
#include "widgets/commands/shortcut_sheet.h"

namespace usar::app {

KeyDesk::KeyDesk(const DeskContext& context)
    : Desk(context)
    , file_(QFileInfo(QSettings().fileName()).path() + "/keys.json") {
    disk_.setMaxThreadCount(1);
}

void KeyDesk::registerCommands() {
    add("help.shortcuts", [this] {
        if (!sheet_) {
            sheet_ = widgets::makeShortcutSheet(commands_, window_);
            sheet_->setAttribute(Qt::WA_DeleteOnClose);
        }
        sheet_->show();
        sheet_->raise();
        sheet_->activateWindow();
    });
}

void KeyDesk::wire() {
    read();
    connect(&commands_, &widgets::CommandRegistry::keysChanged, this, &KeyDesk::write);
}

void KeyDesk::read() {
    QFile file(file_);
    if (!file.open(QIODevice::ReadOnly))
        return; // No key was ever changed.
    const auto keys = widgets::readKeys(file.readAll(), file_);
    if (!keys)
        return notices_.complain("keys", keys.error());
    commands_.takeKeys(*keys);
}

void KeyDesk::write() {
    disk_.start(HandedOver([this, path = file_, text = widgets::keysText(commands_.changedKeys())] {
        QDir().mkpath(QFileInfo(path).path());
        QSaveFile file(path);
        if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
            return;
        QMetaObject::invokeMethod(this, HandedOver([this, path] {
                                      notices_.complain("keys",
                                                        {"the changed keys cannot be kept", path.toStdString(),
                                                         "Make room there, or they are lost when the program ends"});
                                  }),
                                  Qt::QueuedConnection);
    }));
}

} // namespace usar::app
