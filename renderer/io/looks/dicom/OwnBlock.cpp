// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/OwnBlock.h"

#include "io/reading/ReadError.h"

#include <dcmtk/dcmdata/dcvrlo.h>
#include <dcmtk/dcmdata/dcvrui.h>
#include <dcmtk/dcmdata/dcvrus.h>
#include <dcmtk/dcmdata/dcvrut.h>

namespace limn::dicom {
namespace {

constexpr const char* creator = "LIMN";
constexpr const char* volumeWord = "series"; // a scene names its volume; this one is the series referred to
constexpr Uint16 group = 0x4C49;
constexpr Uint16 blockVersion = 1;
const DcmTagKey creatorTag(group, 0x0010), versionTag(group, 0x1001), instanceTag(group, 0x1002),
    sceneTag(group, 0x1003);

template <class Element>
void insert(DcmItem& object, const DcmTagKey& tag, DcmVR vr, const std::string& text) {
  auto* element = new Element(DcmTag(tag, vr)); // the object owns it
  const bool isFilled = element->putOFStringArray(OFString(text.data(), text.size())).good();
  require(object.insert(element, true).good() && isFilled, tag);
}

// An archive that knows no VR of ours hands bytes back (VR UN).
std::string privateText(DcmItem& object, const DcmTagKey& tag) {
  DcmElement* element = nullptr;
  if (object.findAndGetElement(tag, element).bad())
    return {};
  std::string text;
  OFString string;
  Uint8* bytes = nullptr;
  if (element->getUint8Array(bytes).good() && bytes)
    text.assign(reinterpret_cast<const char*>(bytes), element->getLengthField());
  else if (element->getOFStringArray(string, OFFalse).good())
    text.assign(string.c_str(), string.size());
  text.erase(text.find_last_not_of(std::string(" \0", 2)) + 1);
  return text;
}

std::optional<int> versionIn(DcmItem& object) {
  DcmElement* element = nullptr;
  if (object.findAndGetElement(versionTag, element).bad())
    return std::nullopt;
  Uint16 number = 0;
  Uint8* bytes = nullptr;
  if (element->getUint16(number).good())
    return number;
  if (element->getUint8Array(bytes).good() && bytes && element->getLengthField() == 2)
    return bytes[0] | bytes[1] << 8;
  return std::nullopt;
}

} // namespace

void putOwnBlock(DcmItem& object, const Scene& scene, const std::string& instance) {
  Scene kept = scene;
  if (kept.keep.kind == Region::Kind::labels) {
    kept.keep = {}; // labels are another file, which has a name
    kept.keep.cuts = scene.keep.cuts;
  }
  insert<DcmLongString>(object, creatorTag, EVR_LO, creator);
  require(object.putAndInsertUint16(DcmTag(versionTag, EVR_US), blockVersion).good(), versionTag);
  insert<DcmUniqueIdentifier>(object, instanceTag, EVR_UI, instance);
  insert<DcmUnlimitedText>(object, sceneTag, EVR_UT, sceneToJson(kept, volumeWord));
}

std::optional<SceneDocument> ownBlockIn(DcmItem& object, const std::string& name,
                                        std::vector<Message>& changes) {
  if (privateText(object, creatorTag) != creator)
    return std::nullopt;
  if (versionIn(object) != blockVersion) {
    changes.push_back(
        Message::tr("It was written by a later Limn, so what only that knows was left aside: update Limn."));
    return std::nullopt;
  }
  if (privateText(object, instanceTag) != textIn(object, DCM_SOPInstanceUID)) {
    changes.push_back(Message::tr("It was changed by another program since Limn wrote it, so its standard "
                                  "attributes alone were read."));
    return std::nullopt;
  }
  SceneDocument document = parseScene(privateText(object, sceneTag), name);
  document.volume.clear();
  if (document.keep.kind == Region::Kind::labels) // nobody else says which file to open
    document.keep = {Region::Kind::all, {}, {}, document.keep.cuts};
  return document;
}

} // namespace limn::dicom
