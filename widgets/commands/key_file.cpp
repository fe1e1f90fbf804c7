#include "widgets/commands/key_file.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/hand_over.h"
#include "widgets/commands/key_map.h"

namespace usar::widgets {

KeyFile::KeyFile(CommandRegistry& commands, QString file) : commands_(commands), file_(std::move(file)) {
    disk_.setMaxThreadCount(1);
    connect(&commands, &CommandRegistry::keysChanged, this, &KeyFile::write);
}

void KeyFile::read() {
    QFile file(file_);
    if (!file.open(QIODevice::ReadOnly))
        return;
    const auto keys = readKeys(file.readAll(), file_);
    if (!keys) {
        emit failed(keys.error());
        return;
    }
    const QSignalBlocker quiet(commands_); // What was read need not be written.
    commands_.takeKeys(*keys);
}

void KeyFile::write() {
    disk_.start(HandedOver([this, path = file_, text = keysText(commands_.changedKeys())] {
        QDir().mkpath(QFileInfo(path).path());
        QSaveFile file(path);
        if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
            return;
        QMetaObject::invokeMethod(this, HandedOver([this, path] {
                                      emit failed({"the changed keys cannot be kept", path.toStdString(),
                                                   "Make room there, or they are lost when the program ends"});
                                  }),
                                  Qt::QueuedConnection);
    }));
}

} // namespace usar::widgets
