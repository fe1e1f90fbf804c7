#include "widgets/models/control_words.h"

#include <QObject>

namespace usar::widgets {

QString controlText(const ControlWords& words) {
    switch (words.driver) {
    case Driver::Behavior:
        return words.by.isEmpty() ? QObject::tr("a behavior drives") : QObject::tr("%1 drives").arg(words.by);
    case Driver::Person:
        return words.by.isEmpty() ? QObject::tr("you drive") : QObject::tr("you drive · %1").arg(words.by);
    case Driver::Nobody:
        break;
    }
    return QObject::tr("nobody drives");
}

} // namespace usar::widgets
