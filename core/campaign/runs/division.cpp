#include "core/campaign/runs/division.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <sys/file.h>

#include <QDir>

namespace usar::campaign {

namespace {

std::string inParts(int parts) {
    return parts == 1 ? "undivided" : "in " + std::to_string(parts) + " parts";
}

Result<void> writeNumber(QFile& file, const QByteArray& text) {
    file.seek(0);
    if (file.readAll() == text)
        return {};
    if (file.resize(0) && file.seek(0) && file.write(text) == text.size() && file.flush())
        return {};
    return failure("the results cannot be written: " + file.errorString().toStdString(), file.fileName().toStdString(),
                   "Make room, or give another folder with --out");
}

} // namespace

Result<Division> Division::take(const QString& folder, int parts) {
    auto file = std::make_unique<QFile>(QDir(folder).filePath("division"));
    const std::string path = file->fileName().toStdString();
    if (!file->open(QIODevice::ReadWrite | QIODevice::Unbuffered))
        return failure("the results cannot be written: " + file->errorString().toStdString(), path,
                       "Give another folder with --out");
    const QByteArray text = QByteArray::number(parts) + '\n';
    if (::flock(file->handle(), LOCK_EX | LOCK_NB) == 0) // Nobody else flies the campaign.
        if (auto written = writeNumber(*file, text); !written)
            return tl::unexpected(written.error());
    while (::flock(file->handle(), LOCK_SH) != 0) // Another program keeps this waiting only while it writes its number.
        if (errno != EINTR)
            return failure(std::string("the results cannot be locked: ") + std::strerror(errno), path,
                           "Give another folder with --out");
    file->seek(0);
    const int flown = file->readAll().trimmed().toInt();
    if (flown != parts)
        return failure("another program flies this campaign " + inParts(flown) + ", and this one would fly it " +
                           inParts(parts),
                       path, "Wait for it, divide it alike, or give another folder with --out");
    return Division(std::move(file));
}

} // namespace usar::campaign
