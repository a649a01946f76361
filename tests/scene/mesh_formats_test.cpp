// SPDX-License-Identifier: MIT
// OBJ, PLY, FBX and Collada as viewers read them, where Assimp's reader alone does not; and what is
// told of files that give no right picture.
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "scene/import.h"
#include "scene/messages.h"
#include "scene/near.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

class MeshFormats : public testing::Test {
protected:
    Scene load(const std::string &name, const std::string &text) const {
        return imported(folder.write(name, text));
    }

    std::string refusal(const std::string &name, const std::string &text) const {
        return message_of([&] { load(name, text); });
    }

    static const Vertex &corner(const Scene &scene, std::size_t triangle, std::size_t i) {
        return scene.vertices.at(scene.triangles.at(triangle).vertices.at(i));
    }

    static void expect_one_warning(const Scene &scene, const std::string &text) {
        ASSERT_EQ(scene.warnings.size(), 1U);
        EXPECT_NE(scene.warnings[0].find(text), std::string::npos) << scene.warnings[0];
    }

    TemporaryFolder folder;
};

constexpr const char *three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
// IEC 61966-2-1 of a half.
constexpr double half = 0.21404114048223255;

TEST_F(MeshFormats, ObjNumbersMayStartWithAPoint) {
    const Scene scene =
        load("a.obj", "v .5 0 0\nv 1 -.5 .25\nv 0 1 +.5\nvt .5 .25\nvt 1 1\nvt 0 0\n"
                      "f 1/1 2/2 3/3\n");
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, glm::dvec3(0.5, 0, 0)));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(1, -0.5, 0.25)));
    EXPECT_TRUE(is_near(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0.5, 0.75)));
}

TEST_F(MeshFormats, ObjLinesMayBeIndented) {
    EXPECT_EQ(load("a.obj", "  v 0 0 0\n\tv 1 0 0\nv 0 1 0\n  f 1 2 3\n").triangles.size(), 1U);
}

TEST_F(MeshFormats, ObjWeightIsIgnored) {
    const Scene scene = load("a.obj", "v 2 4 6 2\nv 1 0 0 0\nv 0 1 0 1\nf 1 2 3\n");
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, glm::dvec3(2, 4, 6)));
    EXPECT_EQ(corner(scene, 0, 0).color, glm::dvec3(1));
}

TEST_F(MeshFormats, ObjColorsAreSrgbAndWhiteWhereThereIsNone) {
    const Scene scene =
        load("a.obj", "v 0 0 0 1 0 .5\nv 1 0 0\nv 0 1 0 0.5 0 0 1\nv 1 1 0 2 # 1 2\n"
                      "f 1 2 3\nf 2 4 3\n");
    EXPECT_TRUE(is_near(corner(scene, 0, 0).color, glm::dvec3(1, 0, half)));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).color, glm::dvec3(1)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).color, glm::dvec3(half, 0, 0)));
    EXPECT_TRUE(is_near(corner(scene, 1, 1).position, glm::dvec3(1, 1, 0)));
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(1)) << "colours are not seen through a grey";
}

TEST_F(MeshFormats, ObjFacesMayNameWhatTheFileHasNot) {
    for (const char *normals : {"", "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n"}) {
        const Scene scene =
            load("a.obj", std::string(three_vertices) + normals + "f 1/1/1 2/2/2 3/3/3\n");
        ASSERT_EQ(scene.triangles.size(), 1U);
        EXPECT_TRUE(is_near(corner(scene, 0, 2).normal, glm::dvec3(0, 0, 1)));
    }
}

TEST_F(MeshFormats, ObjFacesMayMixTheirForms) {
    const Scene scene =
        load("a.obj", std::string(three_vertices)
                          + "vt 0.5 0.5\nvt 1 1\nvt 0 0\nvn 0 1 0\nvn 0 0 -1\n"
                            "f 1 2/2 3/3\nf 1//1 2 3//2\nf 1/1/2 2/2/2 3/3/2 # 5\n");
    ASSERT_EQ(scene.triangles.size(), 3U);
    EXPECT_TRUE(is_near(corner(scene, 1, 0).normal, glm::dvec3(0, 0, 1))) << "the face's own";
    EXPECT_TRUE(is_near(corner(scene, 2, 0).normal, glm::dvec3(0, 0, -1)));
    EXPECT_TRUE(is_near(corner(scene, 2, 0).texture_coordinates, glm::dvec2(0.5, 0.5)));
}

TEST_F(MeshFormats, MtlMayHaveKeysThatAssimpTripsOver) {
    folder.write("a.mtl", "Kd 0 0 0\nmap_Kd none.png\naniso 0\nnewmtl a\naniso 0.5\nKd 0.25\n"
                          "  d -halo 0.0\nPcr x\n");
    const Scene scene =
        load("a.obj", "mtllib a.mtl\n" + std::string(three_vertices) + "usemtl a\nf 1 2 3\n");
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(0.25));
    EXPECT_EQ(scene.triangles.size(), 1U);
}

constexpr const char *strips = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                               "property float y\nproperty float z\nproperty uchar red\n"
                               "property uchar green\nproperty uchar blue\nelement tristrips 1\n"
                               "property list int int vertex_indices\nend_header\n"
                               "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n1 1 0 188 0 0\n"
                               "5 0 0 0 0 0\n6 0 1 0 0 0\n8 0 1 2 3 -1 3 4 5\n";

TEST_F(MeshFormats, PlyStripsAreTrianglesThatAllFaceOneWay) {
    const Scene scene = load("a.ply", strips);
    ASSERT_EQ(scene.triangles.size(), 3U);
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3 a = corner(scene, i, 0).position;
        EXPECT_GT(glm::cross(corner(scene, i, 1).position - a, corner(scene, i, 2).position - a).z,
                  0)
            << i;
    }
    EXPECT_TRUE(is_near(corner(scene, 2, 2).position, glm::dvec3(6, 0, 1))) << "after the -1";
}

TEST_F(MeshFormats, PlyColorsAreSrgb) {
    const Scene scene = load("a.ply", strips);
    EXPECT_TRUE(is_near(corner(scene, 0, 0).color, glm::dvec3(1, 0, 0)));
    EXPECT_NEAR(corner(scene, 2, 0).color.r, std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
}

TEST_F(MeshFormats, AmfWithoutColorsIsWhite) {
    const Scene scene = load("a.amf", R"(<?xml version="1.0" encoding="UTF-8"?>
<amf unit="millimeter"><object id="1"><mesh><vertices>
<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex>
<vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex>
<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex>
</vertices><volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>
)");
    EXPECT_TRUE(is_near(corner(scene, 0, 0).color, glm::dvec3(1)));
}

// The z axis of the file is up, and its y goes away from the viewer.
constexpr const char *fbx = R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {
    FBXHeaderVersion: 1003
    FBXVersion: 7300
}
GlobalSettings:  {
    Version: 1000
    Properties70:  {
        P: "UpAxis", "int", "Integer", "",UP
        P: "UpAxisSign", "int", "Integer", "",1
        P: "FrontAxis", "int", "Integer", "",FRONT
        P: "FrontAxisSign", "int", "Integer", "",SIGN
        P: "CoordAxis", "int", "Integer", "",0
        P: "CoordAxisSign", "int", "Integer", "",1
        P: "UnitScaleFactor", "double", "Number", "",100
    }
}
Objects:  {
    Geometry: 1, "Geometry::", "Mesh" {
        Vertices: *9 { a: 0,0,0,1,0,0,0,0,2 }
        PolygonVertexIndex: *3 { a: 0,1,-3 }
        GeometryVersion: 124
        LayerElementColor: 0 {
            Version: 101
            Name: ""
            MappingInformationType: "ByPolygonVertex"
            ReferenceInformationType: "Direct"
            Colors: *12 { a: 1,0,0.5,1,1,0,0.5,1,1,0,0.5,1 }
        }
        Layer: 0 {
            Version: 100
            LayerElement:  {
                Type: "LayerElementColor"
                TypedIndex: 0
            }
        }
    }
    Model: 2, "Model::a", "Mesh" {
        Version: 232
    }
}
Connections:  {
    C: "OO",2,0
    C: "OO",1,2
}
)";

std::string fbx_with(const std::string &up, const std::string &front, const std::string &sign) {
    std::string text = fbx;
    text.replace(text.find("UP\n"), 2, up);
    text.replace(text.find("FRONT\n"), 5, front);
    text.replace(text.find("SIGN\n"), 4, sign);
    return text;
}

TEST_F(MeshFormats, FbxStandsUprightInTheSceneUnits) {
    EXPECT_TRUE(is_near(corner(load("a.fbx", fbx_with("2", "1", "-1")), 0, 2).position,
                        glm::dvec3(0, 2, 0)));
    EXPECT_TRUE(is_near(corner(load("a.fbx", fbx_with("1", "2", "1")), 0, 2).position,
                        glm::dvec3(0, 0, 2)));
    EXPECT_TRUE(
        is_near(corner(load("a.fbx", fbx_with("2", "2", "1")), 0, 2).position, glm::dvec3(0, 0, 2)))
        << "axes that are none are ignored";
}

TEST_F(MeshFormats, FbxColorsAreSrgb) {
    EXPECT_TRUE(is_near(corner(load("a.fbx", fbx_with("1", "2", "1")), 0, 0).color,
                        glm::dvec3(1, 0, half)));
}

// Bound at the origin, moved to y = 3 by its joint, whatever the mesh's own node says.
constexpr const char *collada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_controllers><controller id="c"><skin source="#g">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="j"><Name_array id="ja" count="1">bone</Name_array><technique_common>
<accessor source="#ja" count="1" stride="1"><param name="JOINT" type="name"/></accessor>
</technique_common></source>
<source id="m"><float_array id="ma" count="16">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array>
<technique_common><accessor source="#ma" count="1" stride="16"><param name="TRANSFORM" type="float4x4"/>
</accessor></technique_common></source>
<source id="w"><float_array id="wa" count="1">1</float_array><technique_common>
<accessor source="#wa" count="1" stride="1"><param name="WEIGHT" type="float"/></accessor>
</technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#m"/></joints>
<vertex_weights count="3"><input semantic="JOINT" source="#j" offset="0"/>
<input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 1</vcount><v>0 0 0 0 0 0</v>
</vertex_weights></skin></controller></library_controllers>
<library_visual_scenes><visual_scene id="s">
<node id="bone" sid="bone" type="JOINT"><translate>0 3 0</translate></node>
<node id="n"><translate>50 0 0</translate><instance_controller url="#c"><skeleton>#bone</skeleton>
</instance_controller></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST_F(MeshFormats, ColladaJointsBendTheMesh) {
    const Scene scene = load("a.dae", collada);
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, glm::dvec3(0, 3, 0)));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(1, 3, 0)));
}

TEST_F(MeshFormats, PointsAndLinesAreTold) {
    EXPECT_NE(
        refusal("a.obj", std::string(three_vertices) + "l 1 2 3\n").find("only points or lines"),
        std::string::npos);
    expect_one_warning(load("a.obj", std::string(three_vertices) + "f 1 2 3\nl 1 2\n"),
                       "points and lines aren't drawn");
    expect_one_warning(load("a.obj", std::string(three_vertices)
                                         + "v 1 1 1\nv 2 2 2\nv 3 3 3\nv 4 4 4\nf 1 2 3\n"),
                       "its faces use 3 of 7 vertices");
    EXPECT_TRUE(load("a.obj", std::string(three_vertices) + "f 1 2 3\n").warnings.empty());
}

TEST_F(MeshFormats, UnusedVerticesOfAPlyAreTold) {
    const Scene scene = load("a.ply", "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\n"
                                      "property float y\nproperty float z\nelement face 1\n"
                                      "property list uchar int vertex_indices\nend_header\n"
                                      "0 0 0\n1 0 0\n0 1 0\n9 9 9\n9 9 8\n9 9 7\n9 9 6\n3 0 1 2\n");
    expect_one_warning(scene, "its faces use 3 of 7 vertices");
}

TEST_F(MeshFormats, FormatsThatAreNotReadAreToldWithAWayOut) {
    for (const auto &[name, advice] :
         {std::pair{"a.usda", "this is USD, which Blender turns into"},
          std::pair{"a.USDZ", "this is USD, which Blender turns into"},
          std::pair{"a.step", "which FreeCAD turns into"},
          std::pair{"a.3mf", "production extension"}, std::pair{"a.ogex", "OpenGEX"}}) {
        const std::string message = refusal(name, "no mesh of any kind");
        EXPECT_NE(message.find(advice), std::string::npos) << message;
        EXPECT_EQ(message.find("BLENDER"), std::string::npos) << message;
    }
    EXPECT_NE(
        refusal("a.obj", std::string("\xff\xfev\0 \0", 6) + std::string(40, '\0')).find("UTF-16"),
        std::string::npos);
}

TEST_F(MeshFormats, BlackAllOverIsTold) {
    folder.write("a.mtl", "newmtl a\nKd 0 0 0\n");
    expect_one_warning(
        load("a.obj", "mtllib a.mtl\n" + std::string(three_vertices) + "usemtl a\nf 1 2 3\n"),
        "materials that are black");
}

// Assimp's reader of OpenGEX ends the process on this.
TEST_F(MeshFormats, AReaderThatCrashesIsToldWithAWayOut) {
    const std::string message =
        refusal("a.ogex", "GeometryObject {\n Mesh (primitive = \"triangles\") {\n"
                          "  VertexArray (attrib = \"position\") { float[3] {\n"
                          "   {0.0, 1.0, 3.0}, {-1.0, 2.0, 2.0}, {3.0, 3.0, 1.0}\n  }}\n"
                          "  IndexArray { unsigned_int16[3] { {0,1,2} }}\n }\n}\n");
    EXPECT_NE(message.find("crashed"), std::string::npos) << message;
    EXPECT_NE(message.find("Blender turns it into glTF"), std::string::npos) << message;
}

}  // namespace
}  // namespace stagelight
